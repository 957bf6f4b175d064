namespace GTA.Native;

/// <summary>A value that the API passes to natives as eight bytes.</summary>
public interface INativeValue
{
    /// <summary>The eight bytes.</summary>
    ulong NativeValue { get; set; }
}
