float shared_value() { return 1.0; }
