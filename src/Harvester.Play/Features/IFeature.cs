namespace Harvester.Play.Features;

/// <summary>A part of the mod that works on every tick.</summary>
public interface IFeature
{
    /// <summary>The feature's name in messages of failures.</summary>
    string Name { get; }

    /// <summary>Whether it is working. The log records each change.</summary>
    bool IsOn { get; }

    /// <summary>Does the work of one frame.</summary>
    void Tick();

    /// <summary>Ends what it is doing and releases what it took from the game. Calling it again has no effect.</summary>
    void Stop();
}
