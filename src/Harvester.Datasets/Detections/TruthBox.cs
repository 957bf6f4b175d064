using Harvester.Geometry;

namespace Harvester.Datasets.Detections;

/// <summary>A box of the ground truth.</summary>
/// <param name="Class">Index of the class.</param>
/// <param name="Box">The box, pixels.</param>
/// <param name="Area">Area that decides the size range, square pixels: of the pixels where there is a mask, otherwise of the box.</param>
/// <param name="IsCrowd">Whether it is an ignore region: any number of predictions may match it, and none of them counts.</param>
public readonly record struct TruthBox(int Class, Box2D Box, double Area, bool IsCrowd)
{
    /// <summary>
    /// Overlap of a prediction as COCO defines it: intersection over union; for an ignore region, the share of the prediction inside.
    /// </summary>
    /// <param name="predicted">The predicted box.</param>
    /// <returns>0 to 1.</returns>
    public double OverlapWith(Box2D predicted)
    {
        if (predicted.Intersect(Box) is not { } shared)
        {
            return 0;
        }

        double whole = IsCrowd ? predicted.Area : predicted.Area + Box.Area - shared.Area;
        return shared.Area / whole;
    }
}
