using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The game's props, whatever their models; those that nobody knows have the class other.</summary>
public interface IProps
{
    /// <summary>The player's body, which aiming rays pass through.</summary>
    int PlayersBody { get; }

    /// <summary>A prop as it is now; null for what is none, or is gone.</summary>
    EntityState? ReadProp(int entity);

    /// <summary>The props whose origins lie within a distance of a point.</summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IReadOnlyList<EntityState> ReadProps(Vector3D centre, double range);
}
