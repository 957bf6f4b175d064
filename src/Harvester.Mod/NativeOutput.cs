using System.Runtime.InteropServices;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>
/// Memory to which a native writes results, initially zero. The API's own OutputArgument contains garbage beyond its first eight bytes,
/// reads a bool from eight bytes where natives write one or four, and cannot be initialised with an int.
/// </summary>
internal sealed class NativeOutput : IDisposable
{
    /// <summary>Size of an int, a float or a component of a vector in a native's output.</summary>
    private const int SlotBytes = 8;

    private const int SlotsOfAVector = 3;
    private readonly int _slots;
    private IntPtr _memory;

    /// <summary>Allocates zeroed memory.</summary>
    /// <param name="slots">Its size, in slots of eight bytes; by default that of a vector.</param>
    public NativeOutput(int slots = SlotsOfAVector)
    {
        _slots = slots;
        _memory = Marshal.AllocHGlobal(slots * SlotBytes);
        for (int slot = 0; slot < slots; slot++)
        {
            Marshal.WriteInt64(_memory, slot * SlotBytes, 0);
        }
    }

    /// <summary>Whether the BOOL written is true. The rest of its slot is zero, however few bytes the native wrote.</summary>
    public bool IsTrue => Integer != 0;

    /// <summary>The int, hash or handle written.</summary>
    public int Integer => IntegerAt(0);

    /// <summary>The float written.</summary>
    public float Single => SingleAt(0);

    /// <summary>The vector written.</summary>
    public Vector3D Vector => new(SingleAt(0), SingleAt(1), SingleAt(2));

    /// <summary>The address of the memory.</summary>
    public IntPtr Address => _memory != IntPtr.Zero ? _memory : throw new ObjectDisposedException(nameof(NativeOutput));

    /// <summary>The ints in all slots up to the last that is not 0.</summary>
    public int[] Slots
    {
        get
        {
            int count = _slots;
            while (count > 0 && IntegerAt(count - 1) == 0)
            {
                count--;
            }

            int[] integers = new int[count];
            for (int slot = 0; slot < count; slot++)
            {
                integers[slot] = IntegerAt(slot);
            }

            return integers;
        }
    }

    /// <summary>Memory with an int or a handle that the native reads first.</summary>
    public static NativeOutput Holding(int value, int slots = SlotsOfAVector)
    {
        var output = new NativeOutput(slots);
        Marshal.WriteInt32(output._memory, value);
        return output;
    }

    /// <summary>The int or handle in a slot.</summary>
    public int IntegerAt(int slot) => Marshal.ReadInt32(Address, slot * SlotBytes);

    /// <summary>Writes ints into the slots from the first on; those that do not fit are left out.</summary>
    public void Fill(IReadOnlyList<int> integers)
    {
        for (int slot = 0; slot < _slots; slot++)
        {
            Marshal.WriteInt64(Address, slot * SlotBytes, slot < integers.Count ? integers[slot] : 0);
        }
    }

    public void Dispose()
    {
        Marshal.FreeHGlobal(_memory);
        _memory = IntPtr.Zero;
    }

    private float SingleAt(int slot)
    {
        float[] value = new float[1];
        Marshal.Copy(Address + (slot * SlotBytes), value, 0, 1);
        return value[0];
    }
}
