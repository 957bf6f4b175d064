using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>An event that is over.</summary>
/// <param name="Event">The event, without its frames.</param>
/// <param name="ClosedSeconds">The game's time of the reading at which that became known, seconds.</param>
internal sealed record ClosedEvent(DrivingEvent Event, double ClosedSeconds);
