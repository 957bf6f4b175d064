using Harvester.Geometry;

namespace Harvester.Reports.Comparison;

/// <summary>What is compared of an object in an image; null for what its dataset does not say.</summary>
/// <param name="Class">Its class, in the terms of the comparison.</param>
/// <param name="KittiType">Its type in KITTI; null if KITTI does not label it, or the dataset cannot say.</param>
/// <param name="Box">Its box in the image, pixels.</param>
/// <param name="DistanceMetres">Distance from the camera to its centre.</param>
/// <param name="TruncatedFraction">Fraction outside the image, 0 to 1.</param>
/// <param name="OccludedFraction">Fraction hidden, 0 to 1.</param>
/// <param name="Level">Its level of occlusion or visibility, in the terms of the comparison.</param>
/// <param name="ObservationRadians">KITTI's alpha: rotation about the camera's vertical axis minus the direction to the object.</param>
internal readonly record struct ComparedObject(
    string Class,
    string? KittiType,
    Box2D Box,
    double? DistanceMetres,
    double? TruncatedFraction,
    double? OccludedFraction,
    string Level,
    double? ObservationRadians
);
