namespace Harvester.Driving.Scenarios;

/// <summary>A pedestrian crossing across a track.</summary>
/// <param name="At">Its middle, metres along the track.</param>
/// <param name="Left">Its left end, metres to the right of the track; less than 0.</param>
/// <param name="Right">Its right end; more than 0.</param>
internal readonly record struct PlacedCrossing(double At, double Left, double Right);
