using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>The game's road nodes, by its natives.</summary>
internal sealed class GameRoadSource : IRoadSource
{
    /// <inheritdoc/>
    public bool RequestNodes(Vector3D centre, double range)
    {
        float west = (float)(centre.X - range),
            south = (float)(centre.Y - range),
            east = (float)(centre.X + range),
            north = (float)(centre.Y + range);
        Natives.Call(Hash.REQUEST_PATH_NODES_IN_AREA_THIS_FRAME, west, south, east, north);
        return Natives.Call<bool>(Hash.ARE_NODES_LOADED_FOR_AREA, west, south, east, north);
    }

    /// <inheritdoc/>
    public SurveyedNode? NthClosestNode(Vector3D place, int number)
    {
        const int withSwitchedOffAndBoats = 1 | 2;
        const float weightOfHeight = 3;
        const float freeHeight = 0;
        int node = Natives.Call<int>(
            Hash.GET_NTH_CLOSEST_VEHICLE_NODE_ID,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            number,
            withSwitchedOffAndBoats,
            weightOfHeight,
            freeHeight
        );

        // The game crashes if it is asked for the position of an invalid node.
        if (node == 0)
        {
            return null;
        }

        using var position = new NativeOutput();
        Natives.Call(Hash.GET_VEHICLE_NODE_POSITION, node, position);
        return new SurveyedNode(node, position.Vector);
    }

    /// <inheritdoc/>
    public SurveyedProperties? ReadProperties(Vector3D place)
    {
        using var density = new NativeOutput();
        using var flags = new NativeOutput();
        return Natives.Call<bool>(Hash.GET_VEHICLE_NODE_PROPERTIES, (float)place.X, (float)place.Y, (float)place.Z, density, flags)
            ? new SurveyedProperties(density.Integer, flags.Integer)
            : null;
    }

    /// <summary>The link closest to a position, of any length and number of lanes.</summary>
    public SurveyedRoad? ClosestRoad(Vector3D place)
    {
        const float shortestMetres = 0;
        const int minLanes = 0;
        const bool ignoreSwitchedOff = false;
        using var first = new NativeOutput();
        using var second = new NativeOutput();
        using var toFirst = new NativeOutput();
        using var toSecond = new NativeOutput();
        using var median = new NativeOutput();
        return Natives.Call<bool>(
            Hash.GET_CLOSEST_ROAD,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            shortestMetres,
            minLanes,
            first,
            second,
            toFirst,
            toSecond,
            median,
            ignoreSwitchedOff
        )
            ? new SurveyedRoad(first.Vector, second.Vector, toFirst.Integer, toSecond.Integer, median.Single)
            : null;
    }

    /// <inheritdoc/>
    public Vector3D? RoadEdge(Vector3D node, double headingDegrees)
    {
        using var edge = new NativeOutput();
        return Natives.Call<bool>(
            Hash.GET_ROAD_BOUNDARY_USING_HEADING,
            (float)node.X,
            (float)node.Y,
            (float)node.Z,
            (float)headingDegrees,
            edge
        )
            ? edge.Vector
            : null;
    }
}
