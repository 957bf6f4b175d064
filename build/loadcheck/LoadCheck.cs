using System;
using System.IO;
using System.Reflection;

/// <summary>Does what the game's loader does with a scripts folder: loads every dll by LoadFrom and asks for its types.</summary>
internal static class LoadCheck
{
    private static int Main(string[] arguments)
    {
        Assembly api = Assembly.LoadFrom(Path.GetFullPath(arguments[1]));
        AppDomain.CurrentDomain.AssemblyResolve += (sender, request) =>
            new AssemblyName(request.Name).Name == api.GetName().Name ? api : null;
        int scripts = 0;
        foreach (string dll in Directory.GetFiles(arguments[0], "*.dll"))
        {
            try
            {
                int types = 0;
                foreach (Type type in Assembly.LoadFrom(Path.GetFullPath(dll)).GetTypes())
                {
                    types++;
                    scripts += type.BaseType != null && type.BaseType.FullName == "GTA.Script" ? 1 : 0;
                }

                Console.WriteLine("{0}: {1} types", Path.GetFileName(dll), types);
            }
            catch (ReflectionTypeLoadException exception)
            {
                Console.WriteLine(
                    "{0}: {1} types cannot be loaded, such as: {2}",
                    Path.GetFileName(dll),
                    exception.LoaderExceptions.Length,
                    exception.LoaderExceptions[0].Message
                );
                return 1;
            }
        }

        Console.WriteLine("{0} script", scripts);
        return scripts == 1 ? 0 : 1;
    }
}
