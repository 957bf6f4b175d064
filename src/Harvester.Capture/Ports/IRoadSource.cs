using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>
/// The game's functions for its road nodes, as a survey uses them. Positions are given and returned as the game stores them, truncated. All
/// calls come from the game's own thread; exceptions pass through and end the survey.
/// </summary>
public interface IRoadSource
{
    /// <summary>
    /// Asks the game to keep the nodes around a position loaded during this tick, and returns whether they are. Called every tick.
    /// </summary>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Half the side of the area, metres.</param>
    bool RequestNodes(Vector3D centre, double range);

    /// <summary>The n-th closest node for cars to a position, including those without traffic and on water.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="number">n; 1 for the closest.</param>
    /// <returns>Null if there are fewer nodes.</returns>
    SurveyedNode? NthClosestNode(Vector3D place, int number);

    /// <summary>The properties of the node closest to a position.</summary>
    /// <param name="place">Metres, world.</param>
    SurveyedProperties? ReadProperties(Vector3D place);

    /// <summary>
    /// The link closest to a position, of any length and number of lanes, including links without traffic; null if there are no links.
    /// </summary>
    /// <param name="place">Metres, world.</param>
    SurveyedRoad? ClosestRoad(Vector3D place);

    /// <summary>The game's edge of the road that leaves a node in about a direction. It is not reliable.</summary>
    /// <param name="node">Position of the node, metres, world.</param>
    /// <param name="headingDegrees">The direction, degrees counter-clockwise from north.</param>
    /// <returns>Null if the game reports none.</returns>
    Vector3D? RoadEdge(Vector3D node, double headingDegrees);
}
