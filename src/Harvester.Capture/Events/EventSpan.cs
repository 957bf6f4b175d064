using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>An event as far as it is known at a frame.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Kind">What happens.</param>
/// <param name="BeginSeconds">The game's time at which it began, seconds.</param>
/// <param name="EndSeconds">The game's time at which it ended, seconds; infinite while it is open.</param>
internal readonly record struct EventSpan(int Id, EventKind Kind, double BeginSeconds, double EndSeconds);
