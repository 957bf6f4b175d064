using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>How bright the road is in each part of a picture: its asphalt rather than its paint.</summary>
internal sealed class RoadBrightness
{
    /// <summary>The picture has this many rows of blocks, which are square.</summary>
    private const int BlockRows = 12;

    /// <summary>A block is compared with this many rows and columns of blocks around it.</summary>
    private const int RowsAround = 2;
    private const int ColumnsAround = 1;

    /// <summary>Step between the pixels of a row and of a column that are looked at.</summary>
    private const int Step = 2;

    /// <summary>With fewer pixels of road around it, a block has no brightness.</summary>
    private const int MinPixels = 40;

    private readonly int _side;
    private readonly int _across;
    private readonly double?[] _levels;

    /// <param name="map">The class map.</param>
    /// <param name="picture">The picture.</param>
    /// <param name="rank">The rank of the brightness among all pixels of roads and markings around, 0 to 1.</param>
    public RoadBrightness(InstanceMap map, PixelBuffer picture, double rank)
    {
        _side = Math.Max(1, map.Image.Height / BlockRows);
        _across = ((map.Image.Width - 1) / _side) + 1;
        int down = ((map.Image.Height - 1) / _side) + 1;
        var blocks = new List<byte>[_across * down];
        for (int i = 0; i < blocks.Length; i++)
        {
            blocks[i] = [];
        }

        for (int row = 0; row < map.Image.Height; row += Step)
        {
            for (int column = 0; column < map.Image.Width; column += Step)
            {
                int at = (row * map.Image.Width) + column;
                if (map.Ids[at] is (ushort)SemanticClass.Road or (ushort)SemanticClass.LaneMarking)
                {
                    blocks[BlockAt(column, row)].Add((byte)Of(picture.Bytes, at));
                }
            }
        }

        _levels = new double?[blocks.Length];
        List<byte> around = [];
        for (int block = 0; block < blocks.Length; block++)
        {
            around.Clear();
            for (int y = Math.Max(0, (block / _across) - RowsAround); y <= Math.Min(down - 1, (block / _across) + RowsAround); y++)
            {
                for (
                    int x = Math.Max(0, (block % _across) - ColumnsAround);
                    x <= Math.Min(_across - 1, (block % _across) + ColumnsAround);
                    x++
                )
                {
                    around.AddRange(blocks[(y * _across) + x]);
                }
            }

            // The value of the given rank: paint is the brightest part of the road and does not change it.
            around.Sort();
            _levels[block] = around.Count >= MinPixels ? around[(int)(rank * (around.Count - 1))] : null;
        }
    }

    /// <summary>The brightness of the road around a pixel, 0 to 255; null if there is hardly any road.</summary>
    public double? Near(int column, int row) => _levels[BlockAt(column, row)];

    /// <summary>The brightness of a pixel, 0 to 255, by the weights of ITU-R BT.601.</summary>
    public static double Of(byte[] colours, int pixel) =>
        (0.299 * colours[pixel * 3]) + (0.587 * colours[(pixel * 3) + 1]) + (0.114 * colours[(pixel * 3) + 2]);

    private int BlockAt(int column, int row) => ((row / _side) * _across) + (column / _side);
}
