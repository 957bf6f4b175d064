using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Capture.Roads;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>The game's road nodes, by its natives.</summary>
internal sealed class GameRoadSource : IRoadSource
{
    /// <inheritdoc/>
    public bool RequestNodes(Vector3D centre, double range)
    {
        float west = (float)(centre.X - range), south = (float)(centre.Y - range), east = (float)(centre.X + range), north = (float)(centre.Y + range);
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
            (float)place.X, (float)place.Y, (float)place.Z, number, withSwitchedOffAndBoats, weightOfHeight, freeHeight);

        // The game ends when it is asked for the place of a node that is none.
        if (node == 0)
        {
            return null;
        }

        using var position = new OutputArgument();
        Natives.Call(Hash.GET_VEHICLE_NODE_POSITION, node, position);
        return new SurveyedNode(node, Natives.Vector(position));
    }

    /// <inheritdoc/>
    public SurveyedProperties? ReadProperties(Vector3D place)
    {
        using var density = new OutputArgument();
        using var flags = new OutputArgument();
        return Natives.Call<bool>(Hash.GET_VEHICLE_NODE_PROPERTIES, (float)place.X, (float)place.Y, (float)place.Z, density, flags)
            ? new SurveyedProperties(density.GetResult<int>(), flags.GetResult<int>())
            : null;
    }

    /// <summary>The piece of road closest to a point, of any length and number of lanes.</summary>
    public SurveyedRoad? ClosestRoad(Vector3D place)
    {
        const float shortestMetres = 0;
        const int fewestLanes = 0;
        const bool ignoreSwitchedOff = false;
        using var first = new OutputArgument();
        using var second = new OutputArgument();
        using var toFirst = new OutputArgument();
        using var toSecond = new OutputArgument();
        using var median = new OutputArgument();
        return Natives.Call<bool>(
            Hash.GET_CLOSEST_ROAD,
            (float)place.X, (float)place.Y, (float)place.Z, shortestMetres, fewestLanes, first, second, toFirst, toSecond, median, ignoreSwitchedOff)
            ? new SurveyedRoad(Natives.Vector(first), Natives.Vector(second), toFirst.GetResult<int>(), toSecond.GetResult<int>(), median.GetResult<float>())
            : null;
    }

    /// <inheritdoc/>
    public Vector3D? RoadEdge(Vector3D node, double headingDegrees)
    {
        using var edge = new OutputArgument();
        return Natives.Call<bool>(Hash.GET_ROAD_BOUNDARY_USING_HEADING, (float)node.X, (float)node.Y, (float)node.Z, (float)headingDegrees, edge)
            ? Natives.Vector(edge)
            : null;
    }
}
