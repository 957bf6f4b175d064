namespace Harvester.Play.Features;

/// <summary>The camera on the player's vehicle.</summary>
public interface IMount
{
    /// <summary>Whether it is mounted.</summary>
    bool IsMounted { get; }

    /// <summary>Mounts it; reports to the player if that is impossible.</summary>
    void Mount();

    /// <summary>Moves it back to its usual place and field of view, after it took those of a rig.</summary>
    void MoveBack();
}
