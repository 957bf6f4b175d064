using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Images.Jpeg;

/// <summary>Decodes the scan of a baseline image into the samples of its components: T.81, annex F.2.</summary>
internal sealed class JpegScan
{
    private const int Side = JpegComponent.BlockSide;
    private const int SixteenZeros = 0xF0;
    private const int MaxBitsOfValue = 15;

    /// <summary>Position in the block, by rows, of each coefficient in zigzag order: T.81, figure A.6.</summary>
    private static readonly int[] Places = AlongDiagonals();

    private readonly JpegFrame _frame;
    private readonly int _restartInterval;
    private readonly JpegBits _bits;
    private readonly int[] _previousDc;
    private readonly int[] _block = new int[Side * Side];

    /// <summary>Creates a decoder.</summary>
    /// <param name="frame">The image.</param>
    /// <param name="restartInterval">Number of MCUs between restart markers; 0 for none.</param>
    /// <param name="bytes">The bytes of the scan.</param>
    public JpegScan(JpegFrame frame, int restartInterval, ReadOnlyMemory<byte> bytes)
    {
        _frame = frame;
        _restartInterval = restartInterval;
        _bits = new JpegBits(bytes);
        _previousDc = new int[frame.Components.Count];
    }

    /// <summary>Decodes the scan.</summary>
    /// <exception cref="DatasetFormatException">The scan is damaged; the message refers to the file as "it".</exception>
    public void Decode()
    {
        int count = _frame.Units.Across * _frame.Units.Down;
        for (int unit = 0; unit < count; unit++)
        {
            if (_restartInterval > 0 && unit > 0 && unit % _restartInterval == 0)
            {
                _bits.PassRestart();
                Array.Clear(_previousDc);
            }

            for (int component = 0; component < _frame.Components.Count; component++)
            {
                DecodeBlocks(component, unit % _frame.Units.Across, unit / _frame.Units.Across);
            }

            if (_bits.IsOverrun)
            {
                throw new DatasetFormatException("its pixels are cut off.");
            }
        }
    }

    /// <summary>Diagonals in turn, every second one upwards.</summary>
    private static int[] AlongDiagonals() =>
        [
            .. from place in Enumerable.Range(0, Side * Side)
            let row = place / Side
            let column = place % Side
            let diagonal = row + column
            orderby diagonal, diagonal % 2 == 0 ? column : row
            select place,
        ];

    private void DecodeBlocks(int index, int column, int row)
    {
        JpegComponent component = _frame.Components[index];
        for (int y = row * component.Down; y < (row + 1) * component.Down; y++)
        {
            for (int x = column * component.Across; x < (column + 1) * component.Across; x++)
            {
                ReadBlock(index);
                InverseDct.Transform(_block, component.Samples, (y * Side * component.Stride) + (x * Side), component.Stride);
            }
        }
    }

    private void ReadBlock(int index)
    {
        JpegComponent component = _frame.Components[index];
        Array.Clear(_block);
        _previousDc[index] += _bits.ReadValue(Math.Min(component.Dc.Read(_bits), MaxBitsOfValue));
        _block[0] = _previousDc[index] * component.Quantisation[0];
        for (int place = 1; place < _block.Length; place++)
        {
            int symbol = component.Ac.Read(_bits);
            int bits = symbol & 0xF;
            if (bits == 0 && symbol != SixteenZeros)
            {
                return;
            }

            place += symbol >> 4;
            if (place >= _block.Length)
            {
                throw new DatasetFormatException("its pixels are damaged.");
            }

            _block[Places[place]] = _bits.ReadValue(bits) * component.Quantisation[place];
        }
    }
}
