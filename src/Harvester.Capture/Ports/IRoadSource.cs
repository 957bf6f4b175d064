using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>
/// What a survey asks a game about its road nodes. Positions are given and returned as the game stores them, truncated. All calls
/// come from the game's own thread; a failure is thrown as it is and ends the survey.
/// </summary>
public interface IRoadSource
{
    /// <summary>
    /// Asks the game to keep the nodes around a place loaded during this tick, and says whether they are. It is called every tick.
    /// </summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Half the side of the area, metres.</param>
    bool RequestNodes(Vector3D centre, double range);

    /// <summary>The node for cars that is the n-th closest to a place, those without traffic and on water included.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="number">1 for the closest.</param>
    /// <returns>Null when there are not so many.</returns>
    SurveyedNode? NthClosestNode(Vector3D place, int number);

    /// <summary>What the game says of the node closest to a place.</summary>
    /// <param name="place">Metres, world.</param>
    SurveyedProperties? ReadProperties(Vector3D place);

    /// <summary>
    /// The link closest to a position, of any length and number of lanes, including links without traffic; null if there are no links.
    /// </summary>
    /// <param name="place">Metres, world.</param>
    SurveyedRoad? ClosestRoad(Vector3D place);

    /// <summary>What the game takes for the edge of the road that leaves a node in about a direction; it is not trusted.</summary>
    /// <param name="node">Where the node is, metres, world.</param>
    /// <param name="headingDegrees">The direction, degrees counter-clockwise from north.</param>
    /// <returns>Null when the game does not tell.</returns>
    Vector3D? RoadEdge(Vector3D node, double headingDegrees);
}
