#include "host/gl/pass_timers.h"

namespace shadertwin::gl {

PassTimers::PassTimers(const Context& context, std::size_t passes) : gl_(context.functions()) {
  if (!context.has_extension("GL_EXT_disjoint_timer_query") || gl_.GetQueryObjectui64vEXT == nullptr) return;
  timers_.resize(passes);
  milliseconds_.assign(passes, -1.0);
  for (Timer& timer : timers_)
    for (QueryObject& query : timer.queries) query = QueryObject(gl_);
}

void PassTimers::begin(std::size_t pass) {
  if (timers_.empty()) return;
  collect(pass);
  Timer& timer = timers_[pass];
  timer.running = !timer.waiting[timer.next];
  if (timer.running) gl_.BeginQuery(GL_TIME_ELAPSED_EXT, timer.queries[timer.next].name());
}

void PassTimers::end(std::size_t pass) {
  if (timers_.empty() || !timers_[pass].running) return;
  Timer& timer = timers_[pass];
  gl_.EndQuery(GL_TIME_ELAPSED_EXT);
  timer.waiting[timer.next] = true;
  timer.next = (timer.next + 1) % depth;
  timer.running = false;
}

const std::vector<double>& PassTimers::milliseconds() {
  for (std::size_t pass = 0; pass < timers_.size(); ++pass) collect(pass);
  return milliseconds_;
}

void PassTimers::collect(std::size_t pass) {
  Timer& timer = timers_[pass];
  // From the oldest on; results come in order.
  for (std::size_t i = 0; i < depth; ++i) {
    const std::size_t slot = (timer.next + i) % depth;
    if (!timer.waiting[slot]) continue;
    GLuint ready = GL_FALSE;
    gl_.GetQueryObjectuiv(timer.queries[slot].name(), GL_QUERY_RESULT_AVAILABLE, &ready);
    if (ready == GL_FALSE) return;
    GLuint64 nanoseconds = 0;
    gl_.GetQueryObjectui64vEXT(timer.queries[slot].name(), GL_QUERY_RESULT, &nanoseconds);
    milliseconds_[pass] = static_cast<double>(nanoseconds) * 1e-6;
    timer.waiting[slot] = false;
  }
}

}  // namespace shadertwin::gl
