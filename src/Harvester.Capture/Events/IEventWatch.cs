namespace Harvester.Capture.Events;

/// <summary>Finds the events of one kind.</summary>
internal interface IEventWatch
{
    /// <summary>Looks at the road users of a reading, which follows those before it.</summary>
    void Observe(SceneReading reading, EventBook book);
}
