namespace Harvester.Sessions.Events;

/// <summary>An event that is open at the moment of a frame.</summary>
/// <param name="Id">Number of the event in the session, from 1.</param>
/// <param name="Kind">What happens.</param>
public readonly record struct EventMark(int Id, EventKind Kind);
