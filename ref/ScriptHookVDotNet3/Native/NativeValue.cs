using System.Text;
using GTA.Hosting;
using GTA.Math;

namespace GTA.Native;

/// <summary>The API's conversions between managed values and the eight bytes of a native's.</summary>
internal static unsafe class NativeValue
{
    /// <exception cref="InvalidCastException">The value is not null, a string or an <see cref="INativeValue"/>; an int is refused.</exception>
    public static ulong From(object? value) =>
        value switch
        {
            null => 0,
            string text => (ulong)PinnedStrings.Pin(text).ToInt64(),
            INativeValue native => native.NativeValue,
            _ => throw new InvalidCastException($"Unable to cast object of type '{value.GetType()}' to native value"),
        };

    /// <summary>Reads a value: a bool from eight bytes, an int or a float from four, a vector's components eight bytes apart.</summary>
    /// <exception cref="NotSupportedException">The stand-in does not convert to this type; the real API may.</exception>
    public static T To<T>(ulong* value) => (T)Read(typeof(T), value);

    private static object Read(Type type, ulong* value) =>
        type == typeof(bool) ? *value != 0
        : type == typeof(int) ? *(int*)value
        : type == typeof(float) ? *(float*)value
        : type == typeof(Vector3) ? new Vector3(*(float*)value, *(float*)(value + 1), *(float*)(value + 2))
        : type == typeof(string) ? TextAt((byte*)*value)
        : throw new NotSupportedException($"The stand-in converts no native value to {type}.");

    private static string TextAt(byte* text)
    {
        int length = 0;
        while (text is not null && text[length] != 0)
        {
            length++;
        }

        return length == 0 ? string.Empty : Encoding.UTF8.GetString(text, length);
    }
}
