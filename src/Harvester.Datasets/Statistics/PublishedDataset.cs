namespace Harvester.Datasets.Statistics;

/// <summary>The size of a dataset as its makers publish it, to compare a session with.</summary>
/// <param name="Name">Its name.</param>
/// <param name="TrainingImages">Images for training.</param>
/// <param name="TestImages">Images for testing.</param>
/// <param name="Labels">Labelled objects in all images.</param>
public sealed record PublishedDataset(string Name, int TrainingImages, int TestImages, int Labels)
{
    /// <summary>KITTI object detection 2012, as the benchmark's page gives it (Geiger, Lenz, Urtasun 2012).</summary>
    public static PublishedDataset Kitti { get; } = new("KITTI object detection", 7_481, 7_518, 80_256);

    /// <summary>All images.</summary>
    public int Images => TrainingImages + TestImages;

    /// <summary>Labels an image.</summary>
    public double LabelsPerImage => (double)Labels / Images;
}
