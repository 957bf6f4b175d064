using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A link as returned by the game's GET_CLOSEST_ROAD.</summary>
/// <param name="First">The first end that the function returns, the southern one; metres, world, truncated as the game stores it.</param>
/// <param name="Second">The second end, the northern one.</param>
/// <param name="LanesToFirst">The first number of lanes that the function returns: those that lead to the first end.</param>
/// <param name="LanesToSecond">The second number: those that lead to the second end.</param>
/// <param name="MedianWidth">Width of the median, metres; negative if the game does not give it.</param>
public readonly record struct SurveyedRoad(Vector3D First, Vector3D Second, int LanesToFirst, int LanesToSecond, double MedianWidth);
