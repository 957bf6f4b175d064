using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Tests.Surveys.Roads;

/// <summary>A game that answers with nonsense.</summary>
internal sealed class BrokenRoadSource : IRoadSource
{
    public bool RequestNodes(Vector3D centre, double range) => true;

    public SurveyedNode? NthClosestNode(Vector3D place, int number) =>
        number > 3 ? null : new SurveyedNode(number, new Vector3D(number, 0, 0));

    public SurveyedProperties? ReadProperties(Vector3D place) => null;

    public SurveyedRoad? ClosestRoad(Vector3D place) => new SurveyedRoad(new Vector3D(double.NaN, 0, 0), place, -3, 99, 0);

    public Vector3D? RoadEdge(Vector3D node, double headingDegrees) => new Vector3D(double.NaN, 0, 0);
}
