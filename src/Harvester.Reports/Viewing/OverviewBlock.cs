namespace Harvester.Reports.Viewing;

/// <summary>
/// The bytes of some successive frames, as served.js reads them: little-endian, column by column, so that a browser uses them as they are.
/// </summary>
internal static class OverviewBlock
{
    /// <summary>Frames in each block but the last.</summary>
    public const int Frames = 256;

    /// <summary>
    /// Number of frames and of objects as uint32; the values of frames as float32; numbers of frames, moments, views and counts of objects
    /// as uint32; the values of objects as float32, their ids as uint16.
    /// </summary>
    public static byte[] Encode(IReadOnlyList<OverviewFrame> frames)
    {
        OverviewObject[] objects = [.. frames.SelectMany(frame => frame.Objects)];
        using var bytes = new MemoryStream();
        using var writer = new BinaryWriter(bytes);
        writer.Write(frames.Count);
        writer.Write(objects.Length);
        for (int value = 0; value < OverviewFrame.ValueCount; value++)
        {
            foreach (OverviewFrame frame in frames)
            {
                writer.Write(frame.Values[value]);
            }
        }

        foreach (
            Func<OverviewFrame, int> number in new Func<OverviewFrame, int>[]
            {
                frame => frame.Frame,
                frame => frame.Moment,
                frame => frame.View,
                frame => frame.Objects.Length,
            }
        )
        {
            foreach (OverviewFrame frame in frames)
            {
                writer.Write(number(frame));
            }
        }

        foreach (
            Func<OverviewObject, double> value in new Func<OverviewObject, double>[]
            {
                item => item.DistanceMetres,
                item => item.TruncatedFraction,
                item => item.OccludedFraction,
                item => item.Box.XMin,
                item => item.Box.YMin,
                item => item.Box.XMax,
                item => item.Box.YMax,
            }
        )
        {
            foreach (OverviewObject item in objects)
            {
                writer.Write((float)value(item));
            }
        }

        foreach (OverviewObject item in objects)
        {
            writer.Write(item.Id);
        }

        writer.Flush();
        return bytes.ToArray();
    }
}
