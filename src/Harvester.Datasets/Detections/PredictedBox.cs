using Harvester.Geometry;

namespace Harvester.Datasets.Detections;

/// <summary>A predicted box.</summary>
/// <param name="Image">Number of the image.</param>
/// <param name="Class">Index of the class.</param>
/// <param name="Box">The box, pixels.</param>
/// <param name="Score">Confidence; higher is more certain.</param>
public readonly record struct PredictedBox(int Image, int Class, Box2D Box, double Score);
