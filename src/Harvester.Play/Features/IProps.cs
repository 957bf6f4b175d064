using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The game's props of any model; unknown ones have the class other.</summary>
public interface IProps
{
    /// <summary>The player's body, which aiming rays pass through.</summary>
    int PlayersBody { get; }

    /// <summary>The current state of a prop; null if the entity is not a prop or no longer exists.</summary>
    EntityState? ReadProp(int entity);

    /// <summary>The props whose origins lie within a distance of a point.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IReadOnlyList<EntityState> ReadProps(Vector3D centre, double range);
}
