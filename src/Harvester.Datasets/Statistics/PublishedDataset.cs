namespace Harvester.Datasets.Statistics;

/// <summary>Published size of a dataset, for comparison.</summary>
/// <param name="Name">Name of the dataset.</param>
/// <param name="TrainingImages">Number of training images.</param>
/// <param name="TestImages">Number of test images.</param>
/// <param name="Labels">Number of labelled objects in all images.</param>
public sealed record PublishedDataset(string Name, int TrainingImages, int TestImages, int Labels)
{
    /// <summary>KITTI object detection 2012, as on the page of the benchmark (Geiger, Lenz, Urtasun 2012).</summary>
    public static PublishedDataset Kitti { get; } = new("KITTI object detection", 7_481, 7_518, 80_256);

    /// <summary>Number of all images.</summary>
    public int Images => TrainingImages + TestImages;

    /// <summary>Labels per image.</summary>
    public double LabelsPerImage => (double)Labels / Images;
}
