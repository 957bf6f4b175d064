using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>The events of a frame.</summary>
/// <param name="Open">The events that are open at its moment, by ascending id.</param>
/// <param name="Ended">The events that have ended since the frame before, with their frames.</param>
internal sealed record TakenEvents(IReadOnlyList<EventSpan> Open, IReadOnlyList<DrivingEvent> Ended)
{
    /// <summary>The open events as a label names them.</summary>
    public IReadOnlyList<EventMark> Marks => [.. Open.Select(static span => new EventMark(span.Id, span.Kind))];

    /// <summary>All of them with their times.</summary>
    public IReadOnlyList<EventSpan> Spans =>
        [.. Open, .. Ended.Select(static each => new EventSpan(each.Id, each.Kind, each.BeginSeconds, each.EndSeconds))];
}
