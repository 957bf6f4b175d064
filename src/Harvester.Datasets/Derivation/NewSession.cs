using System.Diagnostics;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Derivation;

/// <summary>
/// Writes a session derived from others: the files of its frames, then the manifest, the labels and, last of all, session.json. Each file
/// is written only after everything that it refers to is on the disk.
/// </summary>
internal sealed class NewSession
{
    private readonly string _folder;
    private readonly SyncMode _sync;
    private readonly Action<string, string> _write;
    private readonly SessionJournal? _journal;
    private readonly SyncBatch _batch = new();
    private readonly List<KeyValuePair<string, FileDigest>> _files = [];
    private readonly Stopwatch _age = Stopwatch.StartNew();
    private SpaceWatch? _space;
    private int _frames;

    private NewSession(string folder, SyncMode sync, Action<string, string> write, SessionJournal? journal)
    {
        _folder = folder;
        _sync = sync;
        _write = write;
        _journal = journal;
    }

    /// <summary>Number of frames that an earlier run of a resumed command has ended; they are not to be written again.</summary>
    public int Resumed => _journal?.Resumed ?? 0;

    private bool IsDurable => _sync != SyncMode.Never;

    /// <summary>Writes a session in one go.</summary>
    /// <param name="folder">Where it goes; the folder is made if it is not there.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <param name="content">Writes the frames, then the files that belong to no single frame.</param>
    /// <param name="header">Gives the text of session.json once all frames are written.</param>
    public static void Write(string folder, SyncMode sync, Action<NewSession> content, Func<string> header)
    {
        Directory.CreateDirectory(folder);
        string text = "";
        WriteLines(
            folder,
            sync,
            (labels, manifest) =>
            {
                var session = new NewSession(folder, sync, WriterOf(labels, manifest), null);
                content(session);
                text = header();
                session.End(manifest, text);
            }
        );
        AtomicFile.Write(Path.Combine(folder, SessionInfo.FileName), text, sync != SyncMode.Never);
    }

    /// <summary>
    /// Writes a session that another run can continue, if the folder has the mark of its command: then finished frames are noted in a
    /// journal, which stays until the caller deletes it.
    /// </summary>
    /// <param name="folder">Where it goes; the folder is made if it is not there.</param>
    /// <param name="sync">When to wait for the disk.</param>
    /// <param name="key">The key of the work; see <see cref="WorkKey"/>.</param>
    /// <param name="resume">Whether to keep the frames that an earlier run finished.</param>
    /// <param name="minFreeBytes">Space that stays free on the disk, bytes; 0 watches nothing.</param>
    /// <param name="content">Writes the frames after those in <see cref="Resumed"/>, then the files that belong to no single frame.</param>
    /// <param name="header">Gives the text of session.json once all frames are written.</param>
    public static void Write(
        string folder,
        SyncMode sync,
        string key,
        bool resume,
        long minFreeBytes,
        Action<NewSession> content,
        Func<string> header
    )
    {
        if (!UnfinishedMark.IsIn(folder))
        {
            Write(folder, sync, content, header);
            return;
        }

        using var journal = SessionJournal.Open(folder, key, resume, sync != SyncMode.Never);
        var session = new NewSession(folder, sync, journal.Add, journal) { _space = new SpaceWatch(folder, minFreeBytes) };
        try
        {
            content(session);
        }
        catch (Exception e) when (e is OperationCanceledException or DatasetFormatException or LowSpaceException)
        {
            // The disk is well: the frames whose lines are held back need not be written again.
            session.Commit();
            throw;
        }

        session.Commit();
        string text = header();
        WriteLines(
            folder,
            sync,
            (labels, manifest) =>
            {
                Action<string, string> write = WriterOf(labels, manifest);
                foreach ((string manifestLine, string label) in journal.Read())
                {
                    write(manifestLine, label);
                }

                session.End(manifest, text);
            }
        );
        AtomicFile.Write(Path.Combine(folder, SessionInfo.FileName), text, sync != SyncMode.Never);
    }

    /// <summary>Writes a file of the frame that is ended next.</summary>
    /// <param name="name">Its path within the session.</param>
    /// <param name="content">Writes the content.</param>
    public void WriteFile(string name, Action<Stream> content)
    {
        FileDigest digest = default;
        string path = Prepare(name);
        AtomicFile.Write(path, stream => digest = DigestStream.Write(stream, content), isDurable: false);
        Add(name, path, digest);
    }

    /// <summary>Places a file of another session under the same path.</summary>
    /// <param name="name">Its path within both sessions.</param>
    /// <param name="source">The other session.</param>
    /// <param name="transfer">Whether to link or to copy it.</param>
    /// <param name="digest">Its digest.</param>
    /// <exception cref="DatasetFormatException">There is no such file.</exception>
    public void Place(string name, SessionReader source, ImageTransfer transfer, Func<FileDigest> digest)
    {
        string path = Prepare(name);
        FileTransfer.Place(path, source.PathOf(name), transfer);
        Add(name, path, digest());
    }

    /// <summary>Ends a frame, whose files were written before.</summary>
    /// <param name="frame">Its number.</param>
    /// <param name="line">Its label line.</param>
    public void EndFrame(int frame, string line)
    {
        _write(Manifest.FrameLine(frame, FileDigest.Of(line), _files), line);
        _files.Clear();
        _frames++;
        _space?.Check();
        if (_sync == SyncMode.Always || _frames % SyncBatch.MaxFrames == 0 || (_journal is not null && _age.Elapsed >= SyncBatch.MaxAge))
        {
            Commit();
        }
    }

    private static void WriteLines(string folder, SyncMode sync, Action<TextWriter, TextWriter> write) =>
        AtomicLines.Write(
            Path.Combine(folder, SessionReader.LabelsFile),
            sync != SyncMode.Never,
            labels =>
                AtomicLines.Write(Path.Combine(folder, Manifest.FileName), sync != SyncMode.Never, manifest => write(labels, manifest))
        );

    private static Action<string, string> WriterOf(TextWriter labels, TextWriter manifest) =>
        (manifestLine, label) =>
        {
            manifest.WriteLine(manifestLine);
            labels.WriteLine(label);
        };

    private void Commit()
    {
        _batch.Flush();
        _journal?.Commit();
        _age.Restart();
    }

    private void End(TextWriter manifest, string header)
    {
        foreach (
            KeyValuePair<string, FileDigest> file in _files
                .Append(new(SessionInfo.FileName, FileDigest.Of(header)))
                .OrderBy(file => file.Key, StringComparer.Ordinal)
        )
        {
            manifest.WriteLine(Manifest.FileLine(file.Key, file.Value));
        }

        if (IsDurable)
        {
            _batch.AddFolder(Path.GetDirectoryName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(_folder)))!);
            _batch.Flush();
        }
    }

    private void Add(string name, string path, FileDigest digest)
    {
        _files.Add(new(name, digest));
        if (IsDurable)
        {
            _batch.Add(path);
        }
    }

    private string Prepare(string name)
    {
        string target = InnerPath.Of(_folder, name);
        string folder = Path.GetDirectoryName(target)!;
        if (!Directory.Exists(folder))
        {
            Directory.CreateDirectory(folder);
            if (IsDurable)
            {
                _batch.AddFolder(Path.GetDirectoryName(folder)!);
            }
        }

        return target;
    }
}
