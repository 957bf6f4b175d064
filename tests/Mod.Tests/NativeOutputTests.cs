using System.Runtime.InteropServices;
using GTA.Native;

namespace Harvester.Mod.Tests;

public sealed class NativeOutputTests
{
    private const int Slots = 3;
    private const int SlotBytes = sizeof(ulong);
    private const byte Garbage = 0x7F;

    [Fact]
    public void Memory_is_zero_whatever_it_held_before()
    {
        for (int i = 0; i < 100; i++)
        {
            LeaveGarbage();
            using var output = new NativeOutput(Slots);
            InputArgument place = NativeArgument.ForApi([output])[0];

            Assert.Equal([0, 0, 0], Enumerable.Range(0, Slots).Select(slot => Marshal.ReadInt64((nint)place.Data, slot * SlotBytes)));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    public void Bool_is_read_from_any_number_of_written_bytes(int written)
    {
        foreach (byte value in new byte[] { 0, 1 })
        {
            LeaveGarbage();
            using var output = new NativeOutput();
            InputArgument place = NativeArgument.ForApi([output])[0];
            for (int i = 0; i < written; i++)
            {
                Marshal.WriteByte((nint)place.Data, i, i == 0 ? value : (byte)0);
            }

            Assert.Equal(value == 1, output.IsTrue);
        }
    }

    [Fact]
    public void Memory_holds_a_handle_that_the_native_reads_first()
    {
        const int handle = -5;
        using var output = NativeOutput.Holding(handle);

        Assert.Equal(handle, output.Integer);
    }

    [Fact]
    public void Memory_that_was_freed_is_neither_passed_nor_read()
    {
        var output = new NativeOutput();
        output.Dispose();

        Assert.Throws<ObjectDisposedException>(() =>
        {
            InputArgument place = NativeArgument.ForApi([output])[0];
        });
        Assert.Throws<ObjectDisposedException>(() => output.Integer);
    }

    /// <summary>The next allocation of this size is likely to get this memory.</summary>
    private static void LeaveGarbage()
    {
        nint memory = Marshal.AllocHGlobal(Slots * SlotBytes);
        for (int i = 0; i < Slots * SlotBytes; i++)
        {
            Marshal.WriteByte(memory, i, Garbage);
        }

        Marshal.FreeHGlobal(memory);
    }
}
