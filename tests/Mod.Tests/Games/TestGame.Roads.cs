using GTA.Native;
using Harvester.Capture.Ports;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about roads.</summary>
internal sealed partial class TestGame
{
    private readonly Dictionary<int, SurveyedNode> _roadNodes = [];

    private void AddRoadNatives()
    {
        Do(Hash.REQUEST_PATH_NODES_IN_AREA_THIS_FRAME, _ => { });
        _natives[Hash.ARE_NODES_LOADED_FOR_AREA] = _ => true;
        _natives[Hash.GET_NTH_CLOSEST_VEHICLE_NODE_ID] = a =>
        {
            if (Roads?.NthClosestNode(ToWorld(a[0], a[1], a[2]), (int)a[3]) is not { } node)
            {
                return 0;
            }

            _roadNodes[node.Handle] = node;
            return node.Handle;
        };
        Do(Hash.GET_VEHICLE_NODE_POSITION, a => Write(a[1], ToGame(_roadNodes[(int)a[0]].Position)));
        _natives[Hash.GET_VEHICLE_NODE_PROPERTIES] = a =>
        {
            if (Roads?.ReadProperties(ToWorld(a[0], a[1], a[2])) is not { } properties)
            {
                return false;
            }

            Write(a[3], properties.Density);
            Write(a[4], properties.Flags);
            return true;
        };
        _natives[Hash.GET_CLOSEST_ROAD] = a =>
        {
            if (Roads?.ClosestRoad(ToWorld(a[0], a[1], a[2])) is not { } road)
            {
                return false;
            }

            Write(a[5], ToGame(road.First));
            Write(a[6], ToGame(road.Second));
            Write(a[7], road.LanesToFirst);
            Write(a[8], road.LanesToSecond);
            Write(a[9], (float)road.MedianWidth);
            return true;
        };
        _natives[Hash.GET_ROAD_BOUNDARY_USING_HEADING] = a =>
        {
            if (Roads?.RoadEdge(ToWorld(a[0], a[1], a[2]), (float)a[3]) is not { } edge)
            {
                return false;
            }

            Write(a[4], ToGame(edge));
            return true;
        };
    }
}
