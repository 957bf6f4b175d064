using System;
using System.Runtime.InteropServices;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>
/// Memory that a native writes results to, zero until it does. The API's own OutputArgument holds garbage beyond its first eight bytes at
/// best, reads a bool from eight bytes where natives write one or four, and takes no int to begin with.
/// </summary>
internal sealed class NativeOutput : IDisposable
{
    /// <summary>What natives take for an int, a float or a component of a vector.</summary>
    private const int SlotBytes = 8;

    private const int SlotsOfAVector = 3;
    private IntPtr _memory;

    /// <summary>Makes zeroed memory.</summary>
    /// <param name="slots">Its size, in slots of eight bytes; as much as a vector needs unless said otherwise.</param>
    public NativeOutput(int slots = SlotsOfAVector)
    {
        _memory = Marshal.AllocHGlobal(slots * SlotBytes);
        for (int slot = 0; slot < slots; slot++)
        {
            Marshal.WriteInt64(_memory, slot * SlotBytes, 0);
        }
    }

    /// <summary>Whether the BOOL that was written is true. The rest of its slot is zero, however few bytes the native wrote.</summary>
    public bool IsTrue => Integer != 0;

    /// <summary>The int, hash or handle that was written.</summary>
    public int Integer => IntegerAt(0);

    /// <summary>The float that was written.</summary>
    public float Single => SingleAt(0);

    /// <summary>The vector that was written.</summary>
    public Vector3D Vector => new(SingleAt(0), SingleAt(1), SingleAt(2));

    private IntPtr Memory => _memory != IntPtr.Zero ? _memory : throw new ObjectDisposedException(nameof(NativeOutput));

    public static implicit operator InputArgument(NativeOutput output) => output.Memory;

    /// <summary>Memory that holds an int or a handle which the native reads first.</summary>
    public static NativeOutput Holding(int value, int slots = SlotsOfAVector)
    {
        var output = new NativeOutput(slots);
        Marshal.WriteInt32(output._memory, value);
        return output;
    }

    /// <summary>The int or handle in a slot.</summary>
    public int IntegerAt(int slot) => Marshal.ReadInt32(Memory, slot * SlotBytes);

    public void Dispose()
    {
        Marshal.FreeHGlobal(_memory);
        _memory = IntPtr.Zero;
    }

    private float SingleAt(int slot)
    {
        float[] value = new float[1];
        Marshal.Copy(Memory + (slot * SlotBytes), value, 0, 1);
        return value[0];
    }
}
