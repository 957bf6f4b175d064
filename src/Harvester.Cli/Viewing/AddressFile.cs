using System.Net;

namespace Harvester.Cli.Viewing;

/// <summary>A page in the temporary folder that only the user can read and that leads a browser to an address.</summary>
internal sealed class AddressFile : IDisposable
{
    private readonly DirectoryInfo _folder;

    private AddressFile(DirectoryInfo folder) => _folder = folder;

    /// <summary>Path of the file.</summary>
    public string Path => System.IO.Path.Combine(_folder.FullName, "open.html");

    /// <summary>Writes the file, with mode 0600 in a folder of mode 0700.</summary>
    /// <param name="address">The address.</param>
    /// <exception cref="IOException">It cannot be written.</exception>
    public static AddressFile Create(Uri address)
    {
        var file = new AddressFile(Directory.CreateTempSubdirectory("harvester-view-"));
        var options = new FileStreamOptions { Mode = FileMode.CreateNew, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows())
        {
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        }

        string target = WebUtility.HtmlEncode(address.AbsoluteUri);
        using var writer = new StreamWriter(file.Path, options);
        writer.Write(
            $"<!DOCTYPE html><html lang=\"en\"><meta charset=\"utf-8\"><meta name=\"referrer\" content=\"no-referrer\">"
                + $"<meta http-equiv=\"refresh\" content=\"0; url={target}\"><title>harvester view</title>"
                + $"<p><a href=\"{target}\">Open the viewer</a></p></html>\n"
        );
        return file;
    }

    /// <summary>Removes the file.</summary>
    public void Dispose()
    {
        try
        {
            _folder.Delete(recursive: true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The address in it is no longer served.
        }
    }
}
