namespace Harvester.Play.Features;

/// <summary>The camera on the player's vehicle.</summary>
public interface IMount
{
    /// <summary>Whether it is mounted.</summary>
    bool IsMounted { get; }

    /// <summary>Mounts it; tells the player where that cannot be.</summary>
    void Mount();
}
