using Harvester.Geometry;

namespace Harvester.Capture.Ports;

/// <summary>A link as the game's GET_CLOSEST_ROAD gives it.</summary>
/// <param name="First">The first end that the function returns, the southern one; metres, world, truncated as the game stores it.</param>
/// <param name="Second">The second end, the northern one.</param>
/// <param name="LanesToFirst">The first number of lanes that the function returns: those that lead to the first end.</param>
/// <param name="LanesToSecond">The second number: those that lead to the second end.</param>
/// <param name="MedianWidth">Width of the median, metres; negative where the game does not say.</param>
public readonly record struct SurveyedRoad(Vector3D First, Vector3D Second, int LanesToFirst, int LanesToSecond, double MedianWidth);
