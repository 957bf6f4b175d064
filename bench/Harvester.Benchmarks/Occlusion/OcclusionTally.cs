using System.Globalization;

namespace Harvester.Benchmarks.Occlusion;

/// <summary>What was counted in frames of simulated streets.</summary>
internal sealed class OcclusionTally
{
    private const int PlainPixels = 64;

    /// <summary>Number of frames.</summary>
    public int Frames { get; set; }

    /// <summary>Number of rays.</summary>
    public long Rays { get; set; }

    /// <summary>Occluded fraction by rays less that of the renderer, for each labelled object.</summary>
    public List<double> Errors { get; } = [];

    /// <summary>Visible pixels of each object without a label.</summary>
    public List<int> Missed { get; } = [];

    /// <summary>Adds what was counted elsewhere.</summary>
    public void Add(OcclusionTally other)
    {
        Frames += other.Frames;
        Rays += other.Rays;
        Errors.AddRange(other.Errors);
        Missed.AddRange(other.Missed);
    }

    /// <inheritdoc/>
    public override string ToString() =>
        string.Create(
            CultureInfo.InvariantCulture,
            $"{Frames} frames, {(double)Rays / Frames:F0} rays a frame, {Errors.Count} objects, mean error of the occluded fraction "
                + $"{Errors.Average(Math.Abs):F4}, bias {Errors.Average():F4}, {Missed.Count} visible objects without a label, "
                + $"{Missed.Count(pixels => pixels >= PlainPixels)} of at least {PlainPixels} pixels, {Missed.Sum()} pixels in all"
        );
}
