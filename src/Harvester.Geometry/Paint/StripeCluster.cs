namespace Harvester.Geometry.Paint;

/// <summary>Stripes of several images at one place of a chain.</summary>
/// <param name="Row">Index of the row in the chain.</param>
/// <param name="Station">Metres from the chain's start.</param>
/// <param name="Offset">Weighted median of the middles, metres to the right of the chain.</param>
/// <param name="Width">Median width, metres.</param>
/// <param name="Contrast">Median contrast.</param>
/// <param name="Blueness">Median blueness.</param>
/// <param name="Sigma">Standard deviation of the offset, metres.</param>
/// <param name="Images">Number of images.</param>
internal readonly record struct StripeCluster(
    int Row,
    double Station,
    double Offset,
    double Width,
    double Contrast,
    double Blueness,
    double Sigma,
    int Images
);
