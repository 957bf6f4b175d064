namespace Harvester.Driving.Scenarios;

/// <summary>How far an event is.</summary>
internal enum EventPhase
{
    /// <summary>Its conditions do not hold yet.</summary>
    Waiting,

    /// <summary>They have held; its delay is running.</summary>
    Delayed,

    /// <summary>The actor is doing it.</summary>
    Running,

    /// <summary>It is done.</summary>
    Over,
}
