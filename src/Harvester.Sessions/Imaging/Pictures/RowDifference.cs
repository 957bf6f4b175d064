#if NET
using System.Numerics;
#endif

namespace Harvester.Sessions.Imaging.Pictures;

/// <summary>Differences modulo 256, for the PNG filters that predict a byte by another one.</summary>
internal static class RowDifference
{
    /// <summary>Writes the differences between bytes, to the end of their array, and their predictions.</summary>
    public static void Write(byte[] bytes, int first, byte[] predictions, int firstPrediction, byte[] target, int firstTarget)
    {
        int count = bytes.Length - first;
        int i = 0;
#if NET
        for (; i <= count - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(bytes, first + i) - new Vector<byte>(predictions, firstPrediction + i)).CopyTo(target, firstTarget + i);
        }
#endif
        for (; i < count; i++)
        {
            target[firstTarget + i] = (byte)(bytes[first + i] - predictions[firstPrediction + i]);
        }
    }
}
