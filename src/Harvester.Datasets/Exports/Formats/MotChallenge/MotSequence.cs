using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports.Formats.MotChallenge;

/// <summary>The file seqinfo.ini of a sequence.</summary>
internal static class MotSequence
{
    private const int SecondDecimals = 3;

    /// <summary>What the file needs to know of a frame, as a part.</summary>
    public static string PartOf(ExportFrame frame)
    {
        CameraLabel camera = frame.Label.Camera;
        return FormattableString.Invariant(
            $"{Numbers.Row(SecondDecimals, frame.Label.TimeSeconds)} {camera.Width} {camera.Height} {frame.ImageExtension}");
    }

    /// <summary>Writes the file.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="name">Name of the sequence.</param>
    /// <param name="parts">The parts of its frames.</param>
    public static void Write(TextWriter writer, string name, IEnumerable<string> parts)
    {
        int frames = 0;
        string[] first = [];
        string[] last = [];
        foreach (string part in parts)
        {
            last = part.Split(' ');
            first = frames == 0 ? last : first;
            frames++;
        }

        double seconds = frames > 1 ? Seconds(last) - Seconds(first) : 0;
        double rate = seconds > 0 ? Math.Max(1, Math.Round((frames - 1) / seconds)) : 1;
        writer.Write(FormattableString.Invariant(
            $"[Sequence]\nname={name}\nimDir=img1\nframeRate={rate:0}\nseqLength={frames}\nimWidth={first[1]}\nimHeight={first[2]}\n"));
        writer.Write($"imExt={first[3]}\n");
    }

    private static double Seconds(string[] part) => double.Parse(part[0], CultureInfo.InvariantCulture);
}
