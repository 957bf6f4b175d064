using System.Runtime.InteropServices;
using GTA.Math;

namespace Harvester.Mod.Tests.Games.Natives;

/// <summary>Memory that a native reads or writes.</summary>
/// <param name="place">Its address.</param>
/// <param name="type">What is there.</param>
/// <param name="boolBytes">How many bytes of a BOOL the native writes: 1, 4 or 8.</param>
internal sealed class NativeAddress(IntPtr place, NativeType type, int boolBytes)
{
    private const int SlotBytes = sizeof(ulong);
    private const int VectorSlots = 3;

    public int Integer => Marshal.ReadInt32(place);

    /// <summary>Writes a value; its neighbours keep what they hold.</summary>
    public void Write(object value)
    {
        switch (value)
        {
            case bool truth when type.IsBoolean:
                WriteBoolean(truth);
                break;
            case int integer when !type.IsBoolean && !type.IsSingle && !type.IsVector:
                Marshal.WriteInt32(place, integer);
                break;
            case float single when type.IsSingle:
                WriteSingle(0, single);
                break;
            case Vector3 vector when type.IsVector:
                WriteSingle(0, vector.X);
                WriteSingle(SlotBytes, vector.Y);
                WriteSingle(2 * SlotBytes, vector.Z);
                break;
            default:
                throw new InvalidCastException($"The test game writes {value.GetType()} where the native has {type}.");
        }
    }

    /// <summary>Writes any bits of the type that is there: numbers that are none, and numbers out of every range.</summary>
    public void WriteGarbage(Random random)
    {
        if (type.IsBoolean)
        {
            WriteBoolean(random.Next(2) == 0);
            return;
        }

        for (int slot = 0; slot < (type.IsVector ? VectorSlots : 1); slot++)
        {
            int bits = random.Next(4) == 0 ? random.Next(-2, 3) : random.Next(int.MinValue, int.MaxValue);
            Marshal.WriteInt32(place, slot * SlotBytes, bits);
        }
    }

    /// <summary>
    /// Writes handles as natives write lists of them: the first slot keeps how many there is room for, each further slot gets one.
    /// </summary>
    public int WriteList(IEnumerable<int> handles)
    {
        int count = 0;
        foreach (int handle in handles.Take(Integer))
        {
            Marshal.WriteInt32(place, ++count * SlotBytes, handle);
        }

        return count;
    }

    private void WriteBoolean(bool truth)
    {
        byte low = truth ? (byte)1 : (byte)0;
        switch (boolBytes)
        {
            case sizeof(byte):
                Marshal.WriteByte(place, low);
                break;
            case sizeof(int):
                Marshal.WriteInt32(place, low);
                break;
            default:
                Marshal.WriteInt64(place, low);
                break;
        }
    }

    private void WriteSingle(int offset, float value) => Marshal.WriteInt32(place, offset, BitConverter.SingleToInt32Bits(value));
}
