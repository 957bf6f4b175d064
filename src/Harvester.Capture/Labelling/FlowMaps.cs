using Harvester.Geometry.Motion;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>The flow between a frame and the frame before, in the numbers of docs/flow.md.</summary>
/// <param name="backward">From the pixels of the frame to the frame before, with the motion of the surfaces.</param>
/// <param name="forward">From the pixels of the frame before to the frame.</param>
/// <param name="from">Number of the frame before.</param>
/// <param name="method">Where the depths come from.</param>
/// <param name="raysCast">The rays cast for it alone.</param>
public sealed class FlowMaps(FlowField backward, FlowField forward, int from, SemanticsMethod method, int raysCast) : FramePart
{
    /// <summary>The part of the pixels whose error is estimated not to exceed that of the label.</summary>
    private const double ErrorFraction = 0.95;

    private readonly double? _errorPixels = method == SemanticsMethod.Exact ? null : ErrorOf(backward, forward);

    /// <summary>From the pixels of the frame to the frame before, with the motion of the surfaces.</summary>
    public FlowField Backward => backward;

    /// <summary>From the pixels of the frame before to the frame.</summary>
    public FlowField Forward => forward;

    /// <inheritdoc />
    protected override IReadOnlyList<FileContent> Contents =>
        [
            Deep((row, line) => WriteFlow(backward, row, line)),
            Deep((row, line) => WriteFlow(forward, row, line)),
            Deep((row, line) => WriteMotion(backward, row, line)),
            Flags(backward),
            Flags(forward),
        ];

    /// <inheritdoc />
    public override IChannelLabel LabelIn(FrameKey key) =>
        new FlowLabel(from, method, FlowChannel.FilesOf(key.Frame, key.View)) { ErrorPixels = _errorPixels, RaysCast = raysCast };

    private FileContent Deep(Action<int, byte[]> readRow) => (stream, png) => png.WriteDeepColour(backward.Image, readRow, stream);

    private static FileContent Flags(FlowField field)
    {
        int width = field.Image.Width;
        return (stream, png) =>
            png.WriteGrey8(field.Image, (row, line) => Buffer.BlockCopy(field.Flags, row * width, line, 0, width), stream);
    }

    private static void WriteFlow(FlowField field, int row, byte[] line)
    {
        int at = row * field.Image.Width;
        for (int to = 0; to < line.Length; to += 6, at++)
        {
            bool isValid = (field.At(at) & FlowFlags.Valid) != 0;
            Write(line, to, isValid ? FlowUnits.OfPixels(field.U[at]) : (ushort)0);
            Write(line, to + 2, isValid ? FlowUnits.OfPixels(field.V[at]) : (ushort)0);
            Write(line, to + 4, isValid ? (ushort)1 : (ushort)0);
        }
    }

    private static void WriteMotion(FlowField field, int row, byte[] line)
    {
        float[] motion = field.Motion!;
        int at = 3 * row * field.Image.Width;
        for (int to = 0; to < line.Length; to += 6, at += 3)
        {
            (float right, float down, float forward) = (motion[at], motion[at + 1], motion[at + 2]);
            bool isKnown = FlowUnits.IsMetres(right) && FlowUnits.IsMetres(down) && FlowUnits.IsMetres(forward);
            Write(line, to, isKnown ? FlowUnits.OfMetres(right) : (ushort)0);
            Write(line, to + 2, isKnown ? FlowUnits.OfMetres(down) : (ushort)0);
            Write(line, to + 4, isKnown ? FlowUnits.OfMetres(forward) : (ushort)0);
        }
    }

    private static void Write(byte[] line, int at, ushort number) => (line[at], line[at + 1]) = ((byte)(number >> 8), (byte)number);

    /// <summary>The error that all but a few of the estimates do not exceed, rounded up to a number of flow.</summary>
    private static double ErrorOf(params FlowField[] fields)
    {
        int[] counts = new int[(int)Math.Ceiling(FlowMaker.MaxPixels * FlowUnits.PerPixel) + 1];
        int total = 0;
        foreach (FlowField field in fields.Where(static field => field.ErrorPixels is not null))
        {
            for (int at = 0; at < field.Flags.Length; at++)
            {
                if ((field.At(at) & FlowFlags.Valid) != 0)
                {
                    counts[(int)Math.Ceiling(field.ErrorPixels![at] * FlowUnits.PerPixel)]++;
                    total++;
                }
            }
        }

        int found = 0;
        int number = 0;
        for (; number < counts.Length - 1; number++)
        {
            found += counts[number];
            if (found >= ErrorFraction * total)
            {
                break;
            }
        }

        return number / FlowUnits.PerPixel;
    }
}
