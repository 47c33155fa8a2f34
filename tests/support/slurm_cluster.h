#pragma once

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QThread>

#include <array>
#include <csignal>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <netinet/in.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <unistd.h>

/// Slurm as it is on large machines, here with one node, on ports of the loopback and with all of its files in a temporary
/// folder: munged, slurmctld and slurmd run while this lives, and SLURM_CONF leads to them.
class SlurmCluster {
public:
    SlurmCluster() = default;
    SlurmCluster(const SlurmCluster&) = delete;
    SlurmCluster& operator=(const SlurmCluster&) = delete;

    ~SlurmCluster()
    {
        for (auto program = m_programs.rbegin(); program != m_programs.rend(); ++program) {
            (*program)->terminate();
            if (!(*program)->waitForFinished(10'000))
                (*program)->kill();
            (*program)->waitForFinished(1'000);
        }
    }

    /// @return why it cannot be started; empty when it runs
    QString start()
    {
        for (const char* program : {"munged", "slurmctld", "slurmd"})
            if (pathOf(program).isEmpty())
                return QString(program) + " is not installed";
        writeKey();
        writeConfiguration();
        qputenv("SLURM_CONF", file("slurm.conf").toUtf8());
        launch("munged", {"--foreground", "--force", "--num-threads=1", "--key-file=" + file("munge.key"),
                          "--socket=" + file("munge.socket"), "--pid-file=" + file("munge.pid"),
                          "--log-file=" + file("munge.log"), "--seed-file=" + file("munge.seed")});
        waitUntil([this] { return QFile::exists(file("munge.socket")); });
        launch("slurmctld", {"-D", "-c"});
        launch("slurmd", {"-D"});
        const bool isUp = waitUntil([this] { return answerOf("sinfo", {"-h", "-o", "%T"}).trimmed() == "idle"; });
        return isUp ? QString() : "the node does not come up: " + lastLines();
    }

    static QString answerOf(const QString& command, const QStringList& arguments)
    {
        QProcess process;
        process.start(command, arguments);
        process.waitForFinished(10'000);
        return QString::fromUtf8(process.readAllStandardOutput());
    }

private:
    QString file(const char* name) const { return m_folder.filePath(name); }

    static QString pathOf(const QString& program)
    {
        const QString found = QStandardPaths::findExecutable(program);
        return found.isEmpty() ? QStandardPaths::findExecutable(program, {"/usr/sbin", "/sbin"}) : found;
    }

    void launch(const QString& program, const QStringList& arguments)
    {
        m_programs.push_back(std::make_unique<QProcess>());
        m_programs.back()->setChildProcessModifier(
            [] { prctl(PR_SET_PDEATHSIG, SIGTERM); }); // should the test be killed
        m_programs.back()->setStandardOutputFile(QProcess::nullDevice());
        m_programs.back()->setStandardErrorFile(file(qPrintable(program + ".log")));
        m_programs.back()->start(pathOf(program), arguments);
        m_programs.back()->waitForStarted();
    }

    template <class Condition>
    static bool waitUntil(Condition condition)
    {
        QElapsedTimer timer;
        for (timer.start(); timer.elapsed() < 30'000; QThread::msleep(100))
            if (condition())
                return true;
        return false;
    }

    void writeKey() const
    {
        QFile key(file("munge.key"));
        key.open(QIODevice::WriteOnly);
        key.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
        std::random_device random;
        for (int i = 0; i < 128; ++i)
            key.putChar(static_cast<char>(random()));
    }

    /// A free one, at least just now.
    static int port()
    {
        const int connection = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        bind(connection, reinterpret_cast<sockaddr*>(&address), size);
        getsockname(connection, reinterpret_cast<sockaddr*>(&address), &size);
        close(connection);
        return ntohs(address.sin_port);
    }

    void writeConfiguration() const
    {
        std::array<char, 256> host{};
        gethostname(host.data(), host.size() - 1);
        const QString node = QString(host.data()).section('.', 0, 0);
        const QString user = getpwuid(geteuid())->pw_name;
        QDir(m_folder.path()).mkpath("state");
        QDir(m_folder.path()).mkpath("spool");
        QString text = R"(ClusterName=test
SlurmctldHost=NODE(127.0.0.1)
SlurmctldPort=PORT1
SlurmdPort=PORT2
SlurmUser=USER
SlurmdUser=USER
AuthType=auth/munge
AuthInfo=socket=FOLDER/munge.socket
CredType=cred/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_min_interval=50000,batch_sched_delay=0
ReturnToService=2
StateSaveLocation=FOLDER/state
SlurmdSpoolDir=FOLDER/spool
SlurmctldPidFile=FOLDER/slurmctld.pid
SlurmdPidFile=FOLDER/slurmd.pid
NodeName=NODE NodeAddr=127.0.0.1 CPUs=CORES State=UNKNOWN
PartitionName=main Nodes=NODE Default=YES MaxTime=INFINITE State=UP
)";
        text.replace("FOLDER", m_folder.path()).replace("USER", user).replace("NODE", node);
        text.replace("PORT1", QString::number(port())).replace("PORT2", QString::number(port()));
        text.replace("CORES", QString::number(QThread::idealThreadCount()));
        QFile configuration(file("slurm.conf"));
        configuration.open(QIODevice::WriteOnly);
        configuration.write(text.toUtf8());
    }

    QString lastLines() const
    {
        QString lines;
        for (const char* log : {"munged.log", "slurmctld.log", "slurmd.log"}) {
            QFile content(file(log));
            if (content.open(QIODevice::ReadOnly))
                lines += QString(log) + ": " + QString::fromUtf8(content.readAll()).trimmed().section('\n', -1) + "; ";
        }
        return lines;
    }

    QTemporaryDir m_folder;
    std::vector<std::unique_ptr<QProcess>> m_programs;
};
