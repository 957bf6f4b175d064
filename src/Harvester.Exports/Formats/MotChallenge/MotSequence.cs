using System.Globalization;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.MotChallenge;

/// <summary>The file seqinfo.ini of a sequence.</summary>
internal static class MotSequence
{
    private const int TimeDecimals = 9;

    /// <summary>What the file needs to know of a frame, as a part.</summary>
    public static string PartOf(ExportFrame frame)
    {
        CameraLabel camera = frame.Label.Camera;
        return FormattableString.Invariant($"{Numbers.Row(TimeDecimals, frame.Label.TimeSeconds)} {camera.Width} {camera.Height} ")
            + $"{frame.ImageExtension} {Numbers.Row(TimeDecimals, frame.RateHz)}";
    }

    /// <summary>Writes the file.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="name">Name of the sequence.</param>
    /// <param name="parts">The parts of its frames.</param>
    public static void Write(TextWriter writer, string name, IEnumerable<string> parts)
    {
        string[][] frames = [.. parts.Select(part => part.Split(' '))];
        string[] first = frames[0];
        double rate = Math.Max(1, Math.Round(RateOf([.. frames.Select(frame => Number(frame[0]))], Number(first[4]))));
        writer.Write(FormattableString.Invariant($"[Sequence]\nname={name}\nimDir=img1\nframeRate={rate:0}\nseqLength={frames.Length}\n"));
        writer.Write($"imWidth={first[1]}\nimHeight={first[2]}\nimExt={first[3]}\n");
    }

    /// <summary>The reciprocal of the median time between neighbouring frames, which discarded frames change little.</summary>
    /// <param name="times">Times of the frames, seconds.</param>
    /// <param name="sessionRate">The rate of the session, frames a second; the result for a single frame.</param>
    private static double RateOf(double[] times, double sessionRate)
    {
        double[] steps = [.. times.Zip(times.Skip(1), (before, after) => after - before).Order()];
        double median = steps.Length > 0 ? steps[steps.Length / 2] : 0;
        return median > 0 ? 1 / median : sessionRate;
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);
}
