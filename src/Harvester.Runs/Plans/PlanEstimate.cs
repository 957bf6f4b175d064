using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;

namespace Harvester.Runs.Plans;

/// <summary>
/// An estimate of a plan's frames, time and size, from the figures of docs/performance.md: 22.4 and 13.1 ms for a frame of 800x600 and
/// 280x210, 44.1 and 21.1 ms with masks, and their sizes. A line through the two gives other sizes of images.
/// </summary>
/// <param name="Frames">Number of images.</param>
/// <param name="Seconds">Time on a machine such as that of the figures, seconds.</param>
/// <param name="Bytes">Size of the sessions, bytes.</param>
public sealed record PlanEstimate(long Frames, double Seconds, double Bytes)
{
    private const double SecondsOfTrial = 2;
    private const double SecondsOfFrame = 0.0118;
    private const double SecondsOfPixel = 2.2e-8;
    private const double SecondsOfMaskedFrame = 0.0179;
    private const double SecondsOfMaskedPixel = 5.5e-8;
    private const double BytesOfPixel = 0.43;
    private const double BytesOfMaskPixel = 0.01;
    private const double BytesOfLabelAndScene = 140_000;
    private const double BytesOfPoint = 24;

    /// <summary>The estimate of some trials.</summary>
    public static PlanEstimate Of(PlanFile file, IEnumerable<Trial> trials) =>
        trials
            .Select(trial => Of(file, trial))
            .Aggregate(
                new PlanEstimate(0, 0, 0),
                (sum, each) => new(sum.Frames + each.Frames, sum.Seconds + each.Seconds, sum.Bytes + each.Bytes)
            );

    private static PlanEstimate Of(PlanFile file, Trial trial)
    {
        int moments = file.Plan.FramesAt(trial.Place);
        bool hasMasks = file.Plan.Masks != PlanMasks.Off;
        double[] pixels = file.Rigs.TryGetValue(trial.Camera.Name, out Rig? rig)
            ? [.. rig.Cameras.Select(camera => (double)camera.Image.Width * camera.Image.Height)]
            : [(double)trial.Camera.Image.Width * trial.Camera.Image.Height];
        double points = rig?.Lidars.Sum(lidar => (double)lidar.Columns * lidar.BeamsDegrees.Count) ?? 0;
        double seconds = rig is null
            ? pixels.Sum(each => hasMasks ? SecondsOfMaskedFrame + (SecondsOfMaskedPixel * each) : SecondsOfFrame + (SecondsOfPixel * each))
            : RigBudget.SecondsPerMoment(rig, hasMasks);
        double bytes =
            pixels.Sum(each => BytesOfLabelAndScene + (BytesOfPixel * each) + (hasMasks ? BytesOfMaskPixel * each : 0))
            + (BytesOfPoint * points);
        return new((long)moments * pixels.Length, SecondsOfTrial + (moments * seconds), moments * bytes);
    }

    /// <summary>The estimate in words.</summary>
    public override string ToString()
    {
        TimeSpan time = TimeSpan.FromSeconds(Seconds);
        string duration =
            time.TotalMinutes < 2 ? FormattableString.Invariant($"{time.TotalSeconds:0} s")
            : time.TotalHours < 2 ? FormattableString.Invariant($"{time.TotalMinutes:0} min")
            : FormattableString.Invariant($"{time.TotalHours:0.0} h");
        const double megabyte = 1e6;
        const double gigabyte = 1e9;
        string size =
            Bytes < gigabyte
                ? FormattableString.Invariant($"{Bytes / megabyte:0} MB")
                : FormattableString.Invariant($"{Bytes / gigabyte:0.0} GB");
        return FormattableString.Invariant($"at most {Frames} images, about {duration} and {size}");
    }
}
