namespace Harvester.Geometry.Visibility;

/// <summary>How much of an object's silhouette in the image is hidden.</summary>
/// <param name="OccludedFraction">Fraction of the object's silhouette in the image that lies behind something nearer, 0 to 1; 0 with the
/// method <see cref="OcclusionMethod.None"/>.</param>
/// <param name="SamplesOnObject">Number of samples on which the fraction is based: those that hit the object or would have; of a completely
/// hidden object, only the first.</param>
/// <param name="RaysCast">The number of rays cast for it.</param>
/// <param name="Method">How the fraction was determined.</param>
public readonly record struct OcclusionEstimate(double OccludedFraction, int SamplesOnObject, int RaysCast, OcclusionMethod Method)
{
    /// <summary>Whether any of the object is visible.</summary>
    public Sight Sight { get; init; }
}
