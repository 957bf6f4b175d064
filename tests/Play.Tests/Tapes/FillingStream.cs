namespace Harvester.Play.Tests.Tapes;

/// <summary>A file on a disk that fills up: it takes a part of what is written.</summary>
internal sealed class FillingStream : MemoryStream
{
    /// <summary>Free space, bytes.</summary>
    public long Free { get; set; } = long.MaxValue;

    public override void Write(byte[] buffer, int offset, int count)
    {
        int taken = (int)Math.Min(count, Free);
        base.Write(buffer, offset, taken);
        Free -= taken;
        if (taken < count)
        {
            throw new IOException("No space left on device");
        }
    }
}
