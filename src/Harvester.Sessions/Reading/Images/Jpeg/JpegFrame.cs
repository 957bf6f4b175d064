using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>Size and components of an image, with their samples after decoding: T.81, annexes B.2.2 and B.2.3.</summary>
internal sealed class JpegFrame
{
    private const int ComponentsAt = 6;
    private const int ComponentLength = 3;

    private JpegFrame(ImageSize size, IReadOnlyList<(int Across, int Down)> sampling)
    {
        Size = size;
        Unit = (sampling.Max(factors => factors.Across), sampling.Max(factors => factors.Down));
        Units = (Quotient(size.Width, Unit.Across * JpegComponent.BlockSide), Quotient(size.Height, Unit.Down * JpegComponent.BlockSide));
    }

    /// <summary>Width and height, pixels.</summary>
    public ImageSize Size { get; }

    /// <summary>Blocks per MCU (minimum coded unit) of the component with the highest resolution, horizontally and vertically.</summary>
    public (int Across, int Down) Unit { get; }

    /// <summary>MCUs of the image, horizontally and vertically.</summary>
    public (int Across, int Down) Units { get; }

    /// <summary>One component, or Y, Cb and Cr.</summary>
    public IReadOnlyList<JpegComponent> Components { get; private init; } = [];

    /// <summary>Reads the frame and scan segments.</summary>
    /// <exception cref="InvalidDataException">The segments contradict each other or the tables.</exception>
    public static JpegFrame Read(JpegSegment frame, JpegSegment scan, JpegTables tables)
    {
        (int Across, int Down)[] sampling = [.. Enumerable.Range(0, frame.Components).Select(i => SamplingOf(frame, i))];
        var empty = new JpegFrame(frame.Size, sampling);
        return new JpegFrame(frame.Size, sampling)
        {
            Components = [.. sampling.Select((factors, i) => Component(frame, scan, tables, i, factors, empty.Units))],
        };
    }

    /// <summary>The sample of a component at a pixel of the image.</summary>
    public int Sample(int component, int x, int y)
    {
        JpegComponent samples = Components[component];
        return samples.Samples[(y * samples.Down / Unit.Down * samples.Stride) + (x * samples.Across / Unit.Across)];
    }

    private static (int Across, int Down) SamplingOf(JpegSegment frame, int component)
    {
        const int maxFactor = 4;
        byte factors = frame.Content[ComponentsAt + (ComponentLength * component) + 1];
        (int across, int down) = (factors >> 4, factors & 0xF);
        if (across is < 1 or > maxFactor || down is < 1 or > maxFactor)
        {
            throw new InvalidDataException("Sampling factors are 1 to 4.");
        }

        // If an image has a single component, its MCU is one block, whatever the sampling factors.
        return frame.Components == 1 ? (1, 1) : (across, down);
    }

    private static JpegComponent Component(
        JpegSegment frame,
        JpegSegment scan,
        JpegTables tables,
        int index,
        (int Across, int Down) factors,
        (int Across, int Down) units
    )
    {
        ReadOnlySpan<byte> description = frame.Content.AsSpan(ComponentsAt + (ComponentLength * index), ComponentLength);
        ReadOnlySpan<byte> coding = scan.Content.AsSpan(1 + (2 * index), 2);
        if (coding[0] != description[0])
        {
            throw new InvalidDataException("The scan has the components in another order.");
        }

        return new JpegComponent(factors, units)
        {
            Quantisation = Defined(tables.Quantisation[description[2]]),
            Dc = Defined(tables.Dc[coding[1] >> 4]),
            Ac = Defined(tables.Ac[coding[1] & 0xF]),
        };
    }

    private static T Defined<T>(T? table)
        where T : class => table ?? throw new InvalidDataException("A table is used that is not defined.");

    private static int Quotient(int dividend, int divisor) => (dividend + divisor - 1) / divisor;
}
