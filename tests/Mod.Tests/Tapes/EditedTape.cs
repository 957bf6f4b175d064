using Harvester.Play.Tapes;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>A tape whose entries a test changes.</summary>
internal sealed class EditedTape(byte[] tape)
{
    public List<TapeEntry> Entries { get; } = [.. new TapeReader(new MemoryStream(tape)).Entries()];

    /// <summary>Number of the tick that an entry belongs to.</summary>
    public int TickOf(int index) => Entries.Take(index).Count(entry => entry is TapeTick);

    /// <summary>Number of a call.</summary>
    public int CallOf(int index) => Entries.Take(index + 1).Count(entry => entry is TapeCall or TapeGrab);

    /// <summary>The tape with its changed entries.</summary>
    public byte[] Bytes()
    {
        using var folder = new TemporaryFolder();
        string path = Path.Combine(folder.Path, "edited.tape");
        using (var file = new TapeFile(path))
        {
            file.Append(Encoded());
        }

        return File.ReadAllBytes(path);
    }

    /// <summary>The entries as bytes, without compression.</summary>
    public byte[] Encoded()
    {
        var encoder = new TapeEncoder();
        Entries.ForEach(encoder.Add);
        return encoder.Take();
    }
}
