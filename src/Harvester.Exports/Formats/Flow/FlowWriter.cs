using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Exports.Formats.Flow;

/// <summary>
/// Writes pairs of consecutive images of a view with the optical flow from the first to the second. See docs/exports/flow.md.
/// </summary>
internal sealed class FlowWriter(FlowLayout layout) : IDatasetWriter
{
    private const string ListPrefix = "list ";
    private const int BytesPerDeepPixel = 6;
    private const ushort VisibleValue = 255;

    private readonly PngEncoder _png = new();

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        // The first frame of a place has none before it.
        if (frame.Flow is not { } label)
        {
            return default;
        }

        PairFlow flow = PairFlow.Of(frame, label);
        string name = layout.Name(frame.Index);
        output.ImageBefore($"{layout.First(name)}{frame.ImageExtension}", frame, label);
        output.Image($"{layout.Second(name)}{frame.ImageExtension}", frame);
        foreach ((Func<string, string> path, FlowMapKind kind) in layout.Maps)
        {
            output.File(path(name), stream => Write(flow, kind, stream));
        }

        output.Part(ListPrefix + frame.Split, name);
        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(ListPrefix, StringComparison.Ordinal))
            .Select(part => new AggregateFile(FlowLayout.ListOf(part[ListPrefix.Length..]), [AggregateSection.Lines(part)]));

    private void Write(PairFlow flow, FlowMapKind kind, Stream stream)
    {
        switch (kind)
        {
            case FlowMapKind.Float:
                FloFile.Write(flow, stream);
                break;
            case FlowMapKind.Moved:
                _png.WriteGrey8(Mask(flow, flow.HasMoved, 1), stream);
                break;
            case FlowMapKind.VisibleMask:
                _png.WriteGrey8(Mask(flow, flow.IsVisible, VisibleValue), stream);
                break;
            default:
                Func<int, bool> isWritten = kind == FlowMapKind.All ? flow.IsKnown : flow.IsVisible;
                _png.WriteDeepColour(flow.Image, (row, line) => WriteRow(flow, isWritten, row, line), stream);
                break;
        }
    }

    private static InstanceMap Mask(PairFlow flow, Func<int, bool> isIt, ushort value)
    {
        var mask = new InstanceMap(flow.Image);
        for (int pixel = 0; pixel < mask.Ids.Length; pixel++)
        {
            mask.Ids[pixel] = isIt(pixel) ? value : (ushort)0;
        }

        return mask;
    }

    private static void WriteRow(PairFlow flow, Func<int, bool> isWritten, int row, byte[] line)
    {
        int pixel = row * flow.Image.Width;
        for (int at = 0; at < flow.Image.Width * BytesPerDeepPixel; at += BytesPerDeepPixel, pixel++)
        {
            bool isKnown = isWritten(pixel);
            (ushort right, ushort down) = isKnown ? flow.NumbersAt(pixel) : default;
            (line[at], line[at + 1]) = ((byte)(right >> 8), (byte)right);
            (line[at + 2], line[at + 3]) = ((byte)(down >> 8), (byte)down);
            (line[at + 4], line[at + 5]) = (0, isKnown ? (byte)1 : (byte)0);
        }
    }
}
