using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>The events of a frame.</summary>
/// <param name="Open">The events that are open at its moment.</param>
/// <param name="Ended">The events that have ended since the frame before, with their frames.</param>
internal sealed record TakenEvents(IReadOnlyList<EventMark> Open, IReadOnlyList<DrivingEvent> Ended);
