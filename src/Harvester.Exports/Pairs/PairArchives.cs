using System.Formats.Tar;
using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Pairs;

/// <summary>
/// WebDataset archives (ustar) of moments: one sample each, with the label and all pictures. An archive is written under a temporary name
/// and renamed when it is full. One that an earlier run has written stays if it is as it would be written now.
/// </summary>
/// <param name="folder">Where the archives go.</param>
/// <param name="written">Called with the path of each archive.</param>
internal sealed class PairArchives(string folder, Action<string> written) : IDisposable
{
    /// <summary>After this many bytes of content, the next sample begins another archive.</summary>
    private const long MaxBytes = 1L << 30;

    private static readonly Regex Name = new(@"\Apairs-[0-9]{6}\.tar\z", RegexOptions.CultureInvariant);

    private string? _temporary;
    private FileStream? _stream;
    private TarWriter? _tar;
    private KeptArchive? _kept;
    private long _bytes;
    private int _number;

    private string Current => string.Create(CultureInfo.InvariantCulture, $"pairs-{_number:D6}.tar");

    /// <summary>Whether a file has the name of an archive.</summary>
    public static bool IsName(string name) => Name.IsMatch(name);

    /// <summary>Whether archives of an earlier run may stay.</summary>
    public bool Resumes { get; init; }

    /// <summary>Adds a moment.</summary>
    /// <returns>The name of its archive.</returns>
    /// <exception cref="DatasetFormatException">A picture is missing or too large.</exception>
    public string Add(PairGroup group, SessionReader session)
    {
        if (_bytes >= MaxBytes)
        {
            End();
            _number++;
        }

        if (_tar is null && _kept is null)
        {
            _kept = Resumes ? KeptArchive.Open(Path.Combine(folder, Current)) : null;
            if (_kept is null)
            {
                Begin(null);
            }
        }

        Add($"{group.Key}.json", Encoding.UTF8.GetBytes(group.Line.Text));
        foreach (PairImage image in group.Images)
        {
            Add($"{group.Key}.{image.Name}", InputFile.ReadAllBytes(session.PathOf(image.Path), InputFile.MaxPictureBytes));
        }

        return Current;
    }

    /// <summary>Completes the archive that is being written, if there is one.</summary>
    public void End()
    {
        if (_kept is { } kept && !kept.IsAtEnd())
        {
            // The writer ends an archive only if it has written an entry.
            Rewrite(kept);
            _stream!.Write(new byte[KeptArchive.EndBytes]);
        }

        string file = Path.Combine(folder, Current);
        if (_tar is not null)
        {
            _tar.Dispose();
            _tar = null;
            File.Move(_temporary!, file, overwrite: true);
            written(file);
        }
        else if (_kept is not null)
        {
            _kept.Dispose();
            _kept = null;
            written(file);
        }

        _bytes = 0;
    }

    /// <summary>Deletes archives of an earlier run that have higher numbers than the last one.</summary>
    public void DeleteHigher()
    {
        foreach (string file in Directory.GetFiles(folder))
        {
            if (IsName(Path.GetFileName(file)) && string.CompareOrdinal(Path.GetFileName(file), Current) > 0)
            {
                File.Delete(file);
            }
        }
    }

    /// <summary>Deletes an archive that is not complete.</summary>
    public void Dispose()
    {
        _kept?.Dispose();
        if (_tar is not null)
        {
            _tar.Dispose();
            File.Delete(_temporary!);
        }
    }

    private void Add(string name, byte[] content)
    {
        _bytes += content.Length;
        if (_kept is { } kept)
        {
            if (kept.Has(BytesOf(name, content)))
            {
                return;
            }

            Rewrite(kept);
        }

        _tar!.WriteEntry(EntryOf(name, content));
    }

    /// <summary>Writes an archive again in place of one that differs from what would be written, from the first difference on.</summary>
    private void Rewrite(KeptArchive kept)
    {
        _kept = null;
        using (kept)
        {
            Begin(kept);
        }
    }

    private void Begin(KeptArchive? kept)
    {
        _temporary = AtomicFile.TemporaryFor(Path.Combine(folder, Current));
        _stream = new FileStream(_temporary, FileMode.CreateNew);
        _tar = new TarWriter(_stream, TarEntryFormat.Ustar, leaveOpen: false);
        kept?.CopyTo(_stream);
    }

    private static byte[] BytesOf(string name, byte[] content)
    {
        var bytes = new MemoryStream();
        using var tar = new TarWriter(bytes, TarEntryFormat.Ustar, leaveOpen: true);
        tar.WriteEntry(EntryOf(name, content));
        return bytes.ToArray();
    }

    private static UstarTarEntry EntryOf(string name, byte[] content) =>
        new(TarEntryType.RegularFile, name)
        {
            ModificationTime = DateTimeOffset.UnixEpoch,
            Mode = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead,
            DataStream = new MemoryStream(content),
        };
}
