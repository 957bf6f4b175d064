namespace Harvester.Play.Features;

/// <summary>A part of the mod that works on every tick.</summary>
public interface IFeature
{
    /// <summary>What it is to the player, as the message of a failure names it.</summary>
    string Name { get; }

    /// <summary>Whether it is at work. When this changes from one tick to the next, the log says so.</summary>
    bool IsOn { get; }

    /// <summary>Does this frame's work.</summary>
    void Tick();

    /// <summary>Ends what it is doing and gives back what it took from the game. Again is no harm.</summary>
    void Stop();
}
